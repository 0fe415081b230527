document.title = 'berm view';
