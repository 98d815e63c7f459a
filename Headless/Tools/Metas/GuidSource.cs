using System.Security.Cryptography;
using System.Text;

namespace Nowpose.Metas;

/// <summary>
/// Creates GUIDs that depend only on the path, so that two people who add the .meta file of the same asset create the same GUID.
/// </summary>
public sealed class GuidSource
{
    readonly HashSet<string> _taken;

    /// <param name="taken">GUIDs that are already used in the project.</param>
    public GuidSource(IEnumerable<string> taken) => _taken = new HashSet<string>(taken);

    /// <summary>
    /// Returns an unused GUID for a path. If an asset that was moved already has the first GUID of the path, returns the next GUID of the path.
    /// </summary>
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
