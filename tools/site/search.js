/* The search of the site: all words must be in a page; those that have them in their title come first. No network. */
'use strict';
(() => {
    const input = document.getElementById('words');
    const list = document.getElementById('found');
    const count = document.getElementById('count');
    const lower = pages.map(([path, title, text]) => [path, title, text, title.toLowerCase(), text.toLowerCase()]);

    function excerpt(text, at) {
        const from = Math.max(0, at - 60);
        return (from > 0 ? '... ' : '') + text.slice(from, at + 140) + ' ...';
    }

    function search() {
        const words = input.value.toLowerCase().split(/\s+/).filter((word) => word);
        const hits = words.length === 0 ? [] : lower.map(([path, title, text, name, all]) => {
            if (!words.every((word) => all.includes(word) || name.includes(word))) {
                return null;
            }
            const often = words.reduce((sum, word) => sum + all.split(word).length - 1, 0);
            return { path, title, text: excerpt(text, Math.max(0, all.indexOf(words[0]))),
                worth: often / Math.sqrt(all.length) + (words.every((word) => name.includes(word)) ? 100 : 0) };
        }).filter((hit) => hit).sort((a, b) => b.worth - a.worth);
        list.replaceChildren(...hits.slice(0, 30).map((hit) => {
            const item = document.createElement('li');
            const link = document.createElement('a');
            link.href = hit.path;
            link.textContent = hit.title;
            item.append(link, document.createElement('br'), hit.text);
            return item;
        }));
        count.textContent = words.length === 0 ? '' : hits.length + (hits.length === 1 ? ' page' : ' pages');
    }

    input.addEventListener('input', search);
    input.value = decodeURIComponent(location.hash.slice(1));
    search();
})();
