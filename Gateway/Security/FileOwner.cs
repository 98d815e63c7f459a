using System.Runtime.InteropServices;

namespace Nowpose.Gateway.Security;

/// <summary>Compares the owner of a file with this process. .NET has no function that gets the owner.</summary>
static class FileOwner
{
    // Constants from linux/stat.h, equal on all processors: the requested fields and their offsets.
    const int AtCurrentFolder = -100;
    const uint UidAndGid = 0x8 | 0x10;
    const int UidAt = 20;
    const int GidAt = 24;
    const int Size = 256;

    /// <summary>Whether a file belongs to another user and to the group of this process. Returns false if this is unknown.</summary>
    public static bool IsOthersForOwnGroup(string path)
    {
        if (!OperatingSystem.IsLinux()) return false;
        var about = new byte[Size];
        try
        {
            if (AskFile(AtCurrentFolder, path, 0, UidAndGid, about) != 0) return false;
            return NumberAt(about, UidAt) != OwnUser() && NumberAt(about, GidAt) == OwnGroup();
        }
        catch (EntryPointNotFoundException)
        {
            // C libraries from before 2018 do not have the function statx.
            return false;
        }
    }

    static uint NumberAt(byte[] about, int place) => BitConverter.ToUInt32(about, place);

    [DllImport("libc", EntryPoint = "statx")]
    static extern int AskFile(int folder, string path, int flags, uint mask, [Out] byte[] about);

    [DllImport("libc", EntryPoint = "geteuid")]
    static extern uint OwnUser();

    [DllImport("libc", EntryPoint = "getegid")]
    static extern uint OwnGroup();
}
