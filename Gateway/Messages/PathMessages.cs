using Nowpose.Gateway.Options;

namespace Nowpose.Gateway.Messages;

/// <summary>Error messages about files that cannot be found, read or written, with remedies.</summary>
/// <remarks>The path can begin with the option that names it, for example <c>--out cell.svg</c>.</remarks>
static class PathMessages
{
    public static string NotFound(string path, string remedy = "correct the path") => $"{path}: file not found; {remedy}";

    public const string CloseElsewhere = "close it in the program that has opened it";

    public static string NotRead(string path, Exception cause) =>
        $"{path}: cannot be read ({OneLine(cause)}); {(FileFault.IsInUse(cause) ? CloseElsewhere : "check the path and its permissions")}";

    public static string NotWritten(string path, Exception cause) =>
        $"{path}: cannot be written ({OneLine(cause)}); "
        + (FileFault.IsInUse(cause) ? CloseElsewhere : "check the path, its permissions and the free space");

    public static string OutputNotWritten(Exception cause) =>
        $"standard output: cannot be written ({OneLine(cause)}); check where it is redirected to, and the free space";

    public static string TooManyLinks(string path, int max) => $"{path} has more than {max} symbolic links; remove the loop";

    static string OneLine(Exception cause) => cause is ArgumentException ? "the path is empty or invalid" : cause.Message.ReplaceLineEndings(" ");
}
