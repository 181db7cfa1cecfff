/** What the static site says when its page is opened as a file; the build puts it in. Braces mark the link. */

export const openedFromFileEn = 'This page needs a server. The same page as one file, which opens from a double-click: {link}';

export const openedFromFileTr = 'Bu sayfa bir sunucu ister. Çift tıklamayla açılan, tek dosyalık aynı sayfa: {link}';
