using System.Security.Cryptography;
using System.Text;

namespace Nowpose.Metas;

/// <summary>
/// Generates new GUIDs that depend on the path only, so that two people who add the .meta of one file get the same.
/// </summary>
public sealed class GuidSource
{
    readonly HashSet<string> _taken;

    /// <param name="taken">GUIDs already used in the project.</param>
    public GuidSource(IEnumerable<string> taken) => _taken = new HashSet<string>(taken);

    /// <summary>Gets a GUID that no other asset has. If the path's first GUID is used by a file that was moved, it gets the next one.</summary>
    public string Next(string path)
    {
        for (var attempt = 0; ; attempt++)
        {
            var guid = Hash(attempt == 0 ? path : $"{path}#{attempt}");
            if (_taken.Add(guid)) return guid;
        }
    }

    static string Hash(string text)
    {
        var digest = SHA256.HashData(Encoding.UTF8.GetBytes("nowpose/" + text));
        return Convert.ToHexStringLower(digest.AsSpan(0, 16));
    }
}
