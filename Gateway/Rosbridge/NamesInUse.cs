namespace Nowpose.Gateway.Rosbridge;

/// <summary>Ensures that each name is used by one client at a time, so that no client can impersonate another. Thread-safe.</summary>
sealed class NamesInUse(TimeProvider time)
{
    /// <summary>
    /// Time since the last use of a name after which another connection may use it. Headsets use their names once a second. After a lost connection,
    /// a headset can use its name again sooner than pings detect the loss.
    /// </summary>
    internal static readonly TimeSpan FreeAfter = TimeSpan.FromSeconds(3);

    readonly Dictionary<string, (object Holder, long Heard)> _held = [];

    /// <summary>Reserves a name for a client, or extends the reservation.</summary>
    /// <returns>False while another client uses the name.</returns>
    public bool TryUse(string name, object holder)
    {
        lock (_held)
        {
            if (_held.TryGetValue(name, out var held) && held.Holder != holder && time.GetElapsedTime(held.Heard) < FreeAfter) return false;
            _held[name] = (holder, time.GetTimestamp());
            return true;
        }
    }

    /// <summary>Releases a name, unless another client uses it.</summary>
    /// <returns>Whether this client was using the name.</returns>
    public bool Release(string name, object holder)
    {
        lock (_held) return _held.TryGetValue(name, out var held) && held.Holder == holder && _held.Remove(name);
    }
}
