namespace Nowpose.Gateway.Messages;

/// <summary>Header of the file that lists the paired headsets, and error messages about this file.</summary>
static class HeadsetListMessages
{
    public const string Head = "# Headsets that this gateway has paired. Remove a line to revoke its token; its connections end immediately.\n";

    public static string NotAnEntry(string path, int line) =>
        $"{path}, line {line}: not an entry of a paired headset; correct or remove the line";

    public static string Unusable(string path, string reason) =>
        $"{path}: the list of paired headsets cannot be used ({reason}); check its permissions and the free space of its disk";

    public static string Full(string path, int max) =>
        $"{path}: already contains {max} headsets, which is the maximum; revoke one with the pairings command";
}
