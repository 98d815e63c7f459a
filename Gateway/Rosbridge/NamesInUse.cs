namespace Nowpose.Gateway.Rosbridge;

/// <summary>Ensures that each name is used by one client at a time, so that no client can impersonate another. Thread-safe.</summary>
sealed class NamesInUse(TimeProvider time)
{
    /// <summary>Headsets report once a second. A headset that reconnects gets its name before pings detect the loss of its old connection.</summary>
    internal static readonly TimeSpan FreeAfter = TimeSpan.FromSeconds(3);

    readonly Dictionary<string, (object Holder, long Heard)> _held = [];

    /// <summary>Tries to reserve a name for a client.</summary>
    /// <returns>False while another client uses it.</returns>
    public bool TryUse(string name, object holder)
    {
        lock (_held)
        {
            if (_held.TryGetValue(name, out var held) && held.Holder != holder && time.GetElapsedTime(held.Heard) < FreeAfter) return false;
            _held[name] = (holder, time.GetTimestamp());
            return true;
        }
    }

    /// <summary>Releases a name, unless another client has it by now.</summary>
    /// <returns>Whether this client had it.</returns>
    public bool Release(string name, object holder)
    {
        lock (_held) return _held.TryGetValue(name, out var held) && held.Holder == holder && _held.Remove(name);
    }
}
