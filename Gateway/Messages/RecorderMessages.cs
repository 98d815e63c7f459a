namespace Nowpose.Gateway.Messages;

/// <summary>Error messages and responses of the recorder.</summary>
static class RecorderMessages
{
    public static string Begun(string path) => $"recording {path}";
    public static string Ended(string path, string problem) => $"recording {path}: {problem}";

    public const string Enabled = "recorder: enabled";
    public const string Disabled = "recorder: disabled";
    public const string Download = "recorder: download of ";

    public const string Deleted = "the file was deleted during the recording, and its lines are lost";
    public const string DiskAlmostFull = "less than 200 MB of the disk are free; delete recordings, or use another disk";
    public const string NoFolder = "recording: no folder is configured; start the gateway with --recordings FOLDER";

    public static string DiskTooSlow(string path, double seconds) =>
        FormattableString.Invariant(
            $"recording {path}: the disk did not store the data within {seconds:0} s; the remaining lines are lost; use a faster disk");

    public const string OnField = "on: must be \"true\" or \"false\"";
    public const string UnknownName = "no recording in the folder has this name; /operations/recordings lists the names";
    public static string FolderNotChecked(string reason) => $"recordings: the folder could not be checked ({reason})";
    public static string FolderNotRead(string reason) => $"the folder of recordings cannot be read ({reason}); check the folder and its permissions";

    public const string RecordWithoutFolder = "--record: needs the option --recordings FOLDER";

    public static string FolderNotCreated(string folder, string reason) =>
        $"--recordings {folder}: the folder cannot be created ({reason}); check the path and its permissions";
}
