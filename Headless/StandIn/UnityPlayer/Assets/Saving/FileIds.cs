using System.Security.Cryptography;
using System.Text;

namespace Nowpose.UnityPlayer.Assets.Saving;

/// <summary>Generates fileIDs from the hierarchy alone, so that the same objects have the same fileIDs on every machine.</summary>
sealed class FileIds
{
    readonly HashSet<long> _taken = new HashSet<long>();

    /// <summary>Returns the path of an object: the names from the root to the object.</summary>
    /// <returns>If siblings have the same name, the second and later ones have a number after the name.</returns>
    public static string PathOf(GameObject gameObject)
    {
        var transform = gameObject.transform;
        var parent = transform.parent;
        if (parent == null) return "/" + gameObject.name;
        var before = 0;
        foreach (Transform sibling in parent)
        {
            if (sibling == transform) break;
            if (sibling.name == transform.name) before++;
        }
        return PathOf(parent.gameObject) + "/" + gameObject.name + (before == 0 ? "" : "#" + before);
    }

    /// <summary>Returns a new positive fileID.</summary>
    /// <param name="what">Description of the object: its class, its path and, if there are several, its number.</param>
    public long Next(string what)
    {
        for (var attempt = 0; ; attempt++)
        {
            var id = Hash(attempt == 0 ? what : what + "#" + attempt);
            if (id != 0 && _taken.Add(id)) return id;
        }
    }

    static long Hash(string text)
    {
        using var sha = SHA256.Create();
        return BitConverter.ToInt64(sha.ComputeHash(Encoding.UTF8.GetBytes(text)), 0) & long.MaxValue;
    }
}
