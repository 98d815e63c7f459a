namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Lists the pictures that the arguments name: files, and the files of folders in the order of their names.</summary>
static class PictureFiles
{
    static readonly string[] Pictures = [".png", ".jpg", ".jpeg"];

    /// <summary>Picture formats that cannot be read. Such files are reported individually with the reason.</summary>
    static readonly string[] OtherPictures = [".heic", ".heif", ".avif", ".webp", ".tif", ".tiff", ".bmp", ".dng", ".cr2", ".cr3", ".nef", ".arw"];
    static readonly string[] Videos = [".mp4", ".mov", ".mkv", ".avi", ".webm", ".m4v"];

    public static bool IsVideo(string path) => Has(path, Videos);

    /// <exception cref="InputException">
    /// A file or folder is missing, a folder has no pictures, or a file is neither a picture nor a video.
    /// </exception>
    public static IReadOnlyList<string> Of(IReadOnlyList<string> arguments)
    {
        var files = arguments.SelectMany(Of).ToList();
        if (files.Count > 1 && files.Any(IsVideo)) throw new InputException(PictureMessages.VideoNotAlone(files.First(IsVideo)));
        return files;
    }

    static IEnumerable<string> Of(string path)
    {
        if (Directory.Exists(path)) return Within(path);
        if (!File.Exists(path)) throw new InputException(PictureMessages.NotFound(path));
        return IsPicture(path) || Has(path, OtherPictures) || IsVideo(path)
            ? [path]
            : throw new InputException(PictureMessages.NotAPicture(path, string.Join(", ", Pictures), string.Join(", ", Videos)));
    }

    static List<string> Within(string folder)
    {
        var files = Directory.GetFiles(folder).Where(path => IsPicture(path) || Has(path, OtherPictures)).Order(new NumberedNames()).ToList();
        return files.Count > 0 ? files : throw new InputException(PictureMessages.NoPictures(folder, string.Join(", ", Pictures)));
    }

    static bool IsPicture(string path) => Has(path, Pictures);

    static bool Has(string path, string[] extensions) => extensions.Contains(Path.GetExtension(path), StringComparer.OrdinalIgnoreCase);
}
