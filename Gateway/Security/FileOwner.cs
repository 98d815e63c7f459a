using System.Runtime.InteropServices;

namespace Nowpose.Gateway.Security;

/// <summary>Gets and sets the owner of a file on Linux. .NET has no functions for this.</summary>
static class FileOwner
{
    // Constants from linux/stat.h, equal on all processors: the requested fields and their offsets.
    const int AtCurrentFolder = -100;
    const uint UidAndGid = 0x8 | 0x10;
    const int UidAt = 20;
    const int GidAt = 24;
    const int Size = 256;

    /// <summary>Whether a file belongs to another user and to the group of this process. Returns false if this is unknown.</summary>
    public static bool IsOthersForOwnGroup(string path) => Of(path) is var (user, group) && user != OwnUser() && group == OwnGroup();

    /// <summary>
    /// Gives a file the owner and the group of another file. Only a privileged process can give a file away; for other processes this has no effect.
    /// </summary>
    public static void Copy(string from, string to)
    {
        if (Of(from) is var (user, group) && Of(to) != (user, group)) _ = SetOwner(to, user, group);
    }

    // Returns null if the owner is unknown.
    static (uint User, uint Group)? Of(string path)
    {
        if (!OperatingSystem.IsLinux()) return null;
        var about = new byte[Size];
        try
        {
            return AskFile(AtCurrentFolder, path, 0, UidAndGid, about) == 0 ? (NumberAt(about, UidAt), NumberAt(about, GidAt)) : null;
        }
        catch (EntryPointNotFoundException)
        {
            // C libraries from before 2018 do not have the function statx.
            return null;
        }
    }

    static uint NumberAt(byte[] about, int place) => BitConverter.ToUInt32(about, place);

    [DllImport("libc", EntryPoint = "statx")]
    static extern int AskFile(int folder, string path, int flags, uint mask, [Out] byte[] about);

    [DllImport("libc", EntryPoint = "chown")]
    static extern int SetOwner(string path, uint user, uint group);

    [DllImport("libc", EntryPoint = "geteuid")]
    static extern uint OwnUser();

    [DllImport("libc", EntryPoint = "getegid")]
    static extern uint OwnGroup();
}
