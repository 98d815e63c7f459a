namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>The pictures given as arguments: files, and the files of folders sorted by name.</summary>
static class PictureFiles
{
    static readonly string[] Pictures = [".png", ".jpg", ".jpeg"];
    static readonly string[] Videos = [".mp4", ".mov", ".mkv", ".avi", ".webm", ".m4v"];

    public static bool IsVideo(string path) => Videos.Contains(Path.GetExtension(path), StringComparer.OrdinalIgnoreCase);

    /// <exception cref="InputException">A file or folder is missing, or a folder has no pictures.</exception>
    public static IReadOnlyList<string> Of(IReadOnlyList<string> arguments)
    {
        var files = arguments.SelectMany(Of).ToList();
        if (files.Count > 1 && files.Any(IsVideo)) throw new InputException($"{files.First(IsVideo)}: a video is evaluated by itself");
        return files;
    }

    static IEnumerable<string> Of(string path)
    {
        if (Directory.Exists(path)) return Within(path);
        if (!File.Exists(path)) throw new InputException($"{path}: there is no such file or folder");
        return IsPicture(path) || IsVideo(path)
            ? [path]
            : throw new InputException($"{path}: is neither a picture ({string.Join(", ", Pictures)}) nor a video ({string.Join(", ", Videos)})");
    }

    static List<string> Within(string folder)
    {
        var files = Directory.GetFiles(folder).Where(IsPicture).Order(new NumberedNames()).ToList();
        return files.Count > 0 ? files : throw new InputException($"{folder}: there are no pictures in it ({string.Join(", ", Pictures)})");
    }

    static bool IsPicture(string path) => Pictures.Contains(Path.GetExtension(path), StringComparer.OrdinalIgnoreCase);
}
