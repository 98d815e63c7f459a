using System.Buffers.Text;
using System.Security.Cryptography;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Pairing;

/// <summary>The paired headsets, which may connect with their own tokens. Thread-safe.</summary>
/// <remarks>The list follows changes of its file. When a line is removed, its token becomes invalid.</remarks>
public sealed class HeadsetList
{
    /// <summary>Maximum number of headsets. Limits the time to check a token, which is compared with every line.</summary>
    const int MaxCount = 1000;

    const int TokenBytes = 32;

    readonly string _path;
    readonly TimeProvider _time;
    readonly object _gate = new();
    readonly FollowedFile<IReadOnlyList<PairedHeadset>> _headsets;

    /// <param name="path">Path of the file, which is created if it does not exist.</param>
    /// <param name="time">Gives the times of pairings; null for the system's time.</param>
    /// <param name="log">Receives a line when the file can no longer be read; null for no log.</param>
    /// <exception cref="InputException">The file is invalid. The message names the file and the line.</exception>
    public HeadsetList(string path, TimeProvider time = null, Action<string> log = null)
    {
        _path = path;
        _time = time ?? TimeProvider.System;
        HeadsetFile.Open(path);
        // Reads a changed file without delay, because each change replaces the complete file.
        _headsets = new FollowedFile<IReadOnlyList<PairedHeadset>>(
            [path], (out string fault) => HeadsetFile.Load(path, out fault), TimeSpan.Zero, log);
    }

    /// <summary>Reads the file again if it has changed.</summary>
    internal void Follow() => _ = _headsets.Current;

    internal string Path => _path;

    /// <inheritdoc cref="FollowedFile{T}.Fault"/>
    internal string Fault => _headsets.Fault;

    /// <summary>Whether the token belongs to a paired headset. The check takes the same time for all tokens.</summary>
    /// <param name="hash">Hash from <see cref="TokenList.HashOf"/>.</param>
    public bool Contains(byte[] hash)
    {
        var isKnown = false;
        foreach (var headset in _headsets.Current)
            isKnown |= CryptographicOperations.FixedTimeEquals(headset.Hash, hash);
        return isKnown;
    }

    /// <summary>Creates a token for a headset and stores its hash. The token itself is not stored.</summary>
    /// <exception cref="InputException">The hash cannot be stored, or there are too many headsets.</exception>
    internal string Add(string name, out PairedHeadset headset)
    {
        var token = Base64Url.EncodeToString(RandomNumberGenerator.GetBytes(TokenBytes));
        lock (_gate)
        {
            if (_headsets.Current.Count >= MaxCount)
                throw new InputException(HeadsetListMessages.Full(_path, MaxCount));
            headset = new PairedHeadset(PairedHeadset.NameOf(name), _time.GetUtcNow().UtcDateTime, TokenList.HashOf(token));
            HeadsetFile.Add(_path, headset);
        }

        return token;
    }
}
