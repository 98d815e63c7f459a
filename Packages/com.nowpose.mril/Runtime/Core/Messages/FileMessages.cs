namespace Nowpose.Messages
{
    /// <summary>Error messages about files.</summary>
    static class FileMessages
    {
        public static string NotRead(string path, string reason) =>
            $"{path}: cannot be read: {reason}; check the path and the file's permissions";

        public static string TooLong(string path, long bytes, int max) => $"{path}: file has {bytes} bytes; the limit is {max}";
        public static string NotSaved(string path, string what, string reason) =>
            $"{path}: the {what} cannot be saved: {reason}; check the folder's permissions and free space";
    }
}
