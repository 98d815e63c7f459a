using System.Buffers.Text;
using System.Security.Cryptography;
using Nowpose.Gateway.Security;

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
    readonly object _gate = new();
    readonly FollowedFile<IReadOnlyList<PairedHeadset>> _headsets;

    /// <param name="path">Made where there is none.</param>
    /// <param name="log">Is told when the file cannot be read any more; null for nobody.</param>
    /// <exception cref="InputException">The file cannot be used; names it and the line.</exception>
    public HeadsetList(string path, TimeProvider time = null, Action<string> log = null)
    {
        _path = path;
        _time = time ?? TimeProvider.System;
        HeadsetFile.Open(path);
        // At once: who writes it keeps all others out meanwhile.
        _headsets = new FollowedFile<IReadOnlyList<PairedHeadset>>(
            [path], (out string fault) => HeadsetFile.Load(path, out fault), TimeSpan.Zero, log);
    }

    /// <summary>Reads the file again if it changed.</summary>
    internal void Follow() => _ = _headsets.Current;

    internal string Path => _path;

    /// <inheritdoc cref="Knows(byte[])"/>
    public bool Knows(string token) => Knows(TokenList.HashOf(token ?? ""));

    /// <summary>Whether the token is a headset's. Takes as long whichever it is.</summary>
    /// <param name="hash">As <see cref="TokenList.HashOf"/> makes it.</param>
    public bool Knows(byte[] hash)
    {
        var isKnown = false;
        foreach (var headset in _headsets.Current)
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
            if (_headsets.Current.Count >= GreatestCount)
                throw new InputException($"{_path}: holds {GreatestCount} headsets already; revoke some");
            headset = new PairedHeadset(PairedHeadset.NameOf(name), _time.GetUtcNow().UtcDateTime, TokenList.HashOf(token));
            HeadsetFile.Add(_path, headset);
        }

        return token;
    }
}
