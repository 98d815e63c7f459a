using System.Security.Cryptography;
using System.Text;

namespace Nowpose.Metas;

/// <summary>
/// New GUIDs, the same for the same path on every machine, so that two people who add the meta of one file agree.
/// </summary>
public sealed class GuidSource
{
    readonly HashSet<string> _taken;

    /// <param name="taken">GUIDs that the project uses already.</param>
    public GuidSource(IEnumerable<string> taken) => _taken = new HashSet<string>(taken);

    /// <summary>A GUID that no other asset has. A path whose first choice moved away with another file gets its next.</summary>
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
