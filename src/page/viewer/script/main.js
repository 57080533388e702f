/* main.js -- all of it put together; where there is no WebGL the text is there all the same. */
fillHead();
fillCertificate();
try {
    setStage();
    setControls();
    setDark(matchMedia('(prefers-color-scheme: dark)').matches);
    change({ layout: model.frames ? 'frames' : 'together', colour: hasStrain ? 'S' : 'plain' });
    canvas.dataset.ready = '1';
} catch (fault) {
    const note = byId('fault');
    note.hidden = false;
    note.textContent = 'The picture needs WebGL, which this browser does not give: ' + fault.message;
}
