using Nowpose.Gateway.Messages;

namespace Nowpose.Cli;

/// <summary>Writes the files and folders that options specify. An error message is one line with the option, the path and the reason.</summary>
static class OutputPath
{
    /// <summary>Creates a folder and calls a function that prepares it.</summary>
    /// <param name="option">The option that names the folder, for example <c>--out</c>.</param>
    /// <param name="prepare">The function; its argument is the full path of the folder.</param>
    /// <exception cref="InputException">The folder is not writable.</exception>
    public static T InFolder<T>(string option, string folder, Func<string, T> prepare)
    {
        try
        {
            return prepare(Directory.CreateDirectory(folder).FullName);
        }
        catch (Exception e) when (IsRefusal(e))
        {
            throw new InputException(PathMessages.NotWritten($"{option}: {folder}", e), e);
        }
    }

    /// <summary>Writes a file.</summary>
    /// <param name="option">The option that names the file, for example <c>--page</c>.</param>
    /// <exception cref="InputException">The file cannot be written.</exception>
    public static void File(string option, string path, Action write)
    {
        try
        {
            write();
        }
        catch (Exception e) when (IsRefusal(e))
        {
            throw new InputException(PathMessages.NotWritten($"{option}: {path}", e), e);
        }
    }

    static bool IsRefusal(Exception e) => e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException;
}
