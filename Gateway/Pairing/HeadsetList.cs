using System.Buffers.Text;
using System.Security.Cryptography;

namespace Nowpose.Gateway.Pairing;

/// <summary>The headsets that may connect with a token of their own. Any thread.</summary>
/// <remarks>Follows its file: a line that somebody removes is a token that counts no longer.</remarks>
public sealed class HeadsetList
{
    /// <summary>More than this no gateway serves; each line is compared at each connection.</summary>
    const int GreatestCount = 1000;

    const int TokenBytes = 32;

    readonly string _path;
    readonly TimeProvider _time;
    readonly Action<string> _log;
    readonly object _gate = new();
    IReadOnlyList<PairedHeadset> _headsets;
    (DateTime Written, long Length) _stamp;
    string _fault;

    /// <param name="path">Made where there is none.</param>
    /// <param name="log">Is told when the file cannot be read any more; null for nobody.</param>
    /// <exception cref="InputException">The file cannot be used; names it and the line.</exception>
    public HeadsetList(string path, TimeProvider time = null, Action<string> log = null)
    {
        _path = path;
        _time = time ?? TimeProvider.System;
        _log = log ?? (_ => { });
        _headsets = HeadsetFile.Open(path);
        _stamp = Stamp();
    }

    /// <summary>Whether the token is a headset's. Takes as long whichever it is.</summary>
    public bool Knows(string token)
    {
        var hash = PairedHeadset.HashOf(token ?? "");
        var isKnown = false;
        foreach (var headset in Current())
            isKnown |= CryptographicOperations.FixedTimeEquals(headset.Hash, hash);
        return isKnown;
    }

    /// <summary>Makes a token for a headset and keeps its hash; the token itself is nowhere else.</summary>
    /// <exception cref="InputException">It cannot be kept, or there are too many.</exception>
    internal string Add(string name, out PairedHeadset headset)
    {
        var token = Base64Url.EncodeToString(RandomNumberGenerator.GetBytes(TokenBytes));
        lock (_gate)
        {
            if (Follow().Count >= GreatestCount)
                throw new InputException($"{_path}: holds {GreatestCount} headsets already; revoke some");
            headset = new PairedHeadset(PairedHeadset.NameOf(name), _time.GetUtcNow().UtcDateTime, PairedHeadset.HashOf(token));
            HeadsetFile.Add(_path, headset);
            Follow();
        }

        return token;
    }

    IReadOnlyList<PairedHeadset> Current()
    {
        lock (_gate)
            return Follow();
    }

    IReadOnlyList<PairedHeadset> Follow()
    {
        var stamp = Stamp();
        if (stamp == _stamp) return _headsets;
        try
        {
            _headsets = HeadsetFile.Load(_path, out var fault);
            _stamp = stamp;
            Tell(fault, "; the other lines hold");
        }
        catch (InputException fault)
        {
            // Somebody may be writing it: what was known goes on, and it is looked at again.
            Tell(fault.Message, "; the former list goes on, also what was removed from it");
        }

        return _headsets;
    }

    void Tell(string fault, string consequence)
    {
        if (fault != null && fault != _fault) _log(fault + consequence);
        _fault = fault;
    }

    // Of a file that is not there the same each time.
    (DateTime, long) Stamp()
    {
        var file = new FileInfo(_path);
        return (file.LastWriteTimeUtc, file.Exists ? file.Length : -1);
    }
}
