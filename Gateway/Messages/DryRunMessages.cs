namespace Nowpose.Gateway.Messages;

/// <summary>Results of a check of the configuration, and error messages about it.</summary>
static class DryRunMessages
{
    public static string RecordingsAreAFile(string path) => $"--recordings {path}: is a file; a folder is needed";
    public static string PortInUse(int port) => $" (port {port} is in use)";
    public static string IsAFolder(string option, string path) => $"{option} {path}: is a folder; a file is needed";

    public static string NoFolder(string option, string path, string folder) =>
        $"{option} {path}: folder {folder} does not exist; create it or correct the path";

    public static string NotWritable(string option, string path, string folder) =>
        $"{option} {path}: this user cannot write into the folder {folder}; change its permissions or the path";

    public static string WarningLog(string warning) => $"warning: {warning}";

    public static string PublishedTwice(string file, string kind, string name, string other) =>
        $"{file}: the {kind} {name} is also in {other}, but only one source can publish it; remove it from one of the two files";

    public static string TooMany(string what, int count, int most) => $"the plants have {count} {what} together; the gateway publishes at most {most}";

    /// <param name="offered">Names of the plants that offer a clock.</param>
    public static string ClockNotOffered(string clock, IReadOnlyList<string> offered)
    {
        var remedy = offered.Count == 0 ? "remove it" : $"select {string.Join(" or ", offered)}";
        return $"--clock {clock}: no plant offers this clock, so headsets cannot synchronise until another source offers it; {remedy}, or add its plant";
    }

    /// <inheritdoc cref="ClockNotOffered"/>
    public static string SeveralClocks(IReadOnlyList<string> offered) =>
        $"the plants offer several clocks: {string.Join(", ", offered)}; the first one that is offered becomes the control clock; select one with --clock NAME";

    public static string MissingJointsLog(IReadOnlyList<string> joints) => $"missing joints: {MissingJoints(joints)}";

    public static string MissingJoints(IReadOnlyList<string> joints)
    {
        var them = joints.Count == 1 ? "it" : "them";
        return $"{string.Join(", ", joints)}; no plant configures {them}, so headsets show no current pose until another source publishes {them}";
    }

    public static string MissingParentsLog(IReadOnlyList<(string Parent, string Frame)> parents) => $"missing parents: {MissingParents(parents)}";

    public static string MissingParents(IReadOnlyList<(string Parent, string Frame)> parents) =>
        $"{string.Join(", ", parents.Select(pair => $"{pair.Parent} of {pair.Frame}"))}; no file has a frame or a link of this name, so headsets do not"
            + " show these objects until another source publishes the frame or describes the robot";
}
