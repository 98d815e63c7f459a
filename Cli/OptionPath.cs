using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Options;

namespace Nowpose.Cli;

/// <summary>
/// Reads and writes the files and folders that options specify. An error message is one line with the option, the path and the reason.
/// </summary>
static class OptionPath
{
    const int BufferBytes = 64 * 1024;

    /// <summary>Creates a folder, checks that it is writable, and calls a function that prepares it.</summary>
    /// <param name="option">The option that names the folder, for example <c>--out</c>.</param>
    /// <param name="prepare">The function; its argument is the full path of the folder.</param>
    /// <exception cref="InputException">The folder is not writable.</exception>
    public static T InFolder<T>(string option, string folder, Func<string, T> prepare)
    {
        return FileFault.Report(
            () =>
            {
                var full = Directory.CreateDirectory(folder).FullName;
                OutputFile.TryIn(full);
                return prepare(full);
            },
            e => PathMessages.NotWritten($"{option}: {folder}", e));
    }

    /// <summary>Reads a file.</summary>
    /// <param name="option">The option that names the file, for example <c>--token-file</c>.</param>
    /// <exception cref="InputException">The file cannot be read.</exception>
    public static T Read<T>(string option, string path, Func<T> read) =>
        FileFault.Report(read, e => PathMessages.NotRead($"{option}: {path}", e));

    /// <summary>Writes a file.</summary>
    /// <param name="option">The option that names the file, for example <c>--page</c>.</param>
    /// <exception cref="InputException">The file cannot be written.</exception>
    public static void Write(string option, string path, Action write) =>
        FileFault.Report(write, e => PathMessages.NotWritten($"{option}: {path}", e));

    /// <summary>Opens a file for writing and creates its folder. Keeps the present contents of the file.</summary>
    /// <param name="option">The option that names the file, for example <c>--record</c>.</param>
    /// <exception cref="InputException">The file cannot be written.</exception>
    public static FileStream Open(string option, string path)
    {
        FileStream file = null;
        Write(option, path, () =>
        {
            Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path)));
            // Other programs may read the file while it grows.
            file = new FileStream(path, FileMode.OpenOrCreate, FileAccess.Write, FileShare.Read, BufferBytes);
        });
        return file;
    }

    /// <summary>Checks that no file to write or to remove is also an input of the command.</summary>
    /// <param name="option">The option that names the outputs.</param>
    /// <param name="inputs">Paths of the inputs; null for an input that was not given.</param>
    /// <exception cref="InputException">An output is an input, or its path is invalid.</exception>
    public static void RequireNoInput(string option, IEnumerable<string> outputs, params string[] inputs)
    {
        foreach (var path in outputs)
            Write(option, path, () =>
            {
                // Two names of the same file can differ, for example below a symbolic link to a folder.
                var target = OutputFile.TargetOf(path);
                if (inputs.Any(input => !string.IsNullOrEmpty(input) && OutputFile.TargetOf(input) == target))
                    throw new InputException(OptionValueMessages.WouldOverwriteInput(option, path));
            });
    }
}
