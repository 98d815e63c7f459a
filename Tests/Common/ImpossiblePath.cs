namespace Nowpose.Tests.Common;

/// <summary>Paths at which no user, not even an administrator, can create a file, on any system.</summary>
static class ImpossiblePath
{
    /// <summary>Gets a path below a file, as if the file were a folder.</summary>
    public static string BelowAFile(string name) => Path.Combine(typeof(ImpossiblePath).Assembly.Location, name);
}
