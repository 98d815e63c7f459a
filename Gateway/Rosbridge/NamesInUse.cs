namespace Nowpose.Gateway.Rosbridge;

/// <summary>Under which name which client speaks: one at a time, so that nobody speaks as another. Any thread.</summary>
sealed class NamesInUse(TimeProvider time)
{
    /// <summary>Headsets speak once a second. One that comes back is let in before pings find out that its old connection is gone.</summary>
    internal static readonly TimeSpan FreeAfter = TimeSpan.FromSeconds(3);

    readonly Dictionary<string, (object Holder, long Heard)> _held = [];

    /// <summary>Takes a name, or says that it is still used.</summary>
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

    /// <summary>Gives a name back; nothing where another client has it by now.</summary>
    /// <returns>Whether this client had it.</returns>
    public bool Release(string name, object holder)
    {
        lock (_held) return _held.TryGetValue(name, out var held) && held.Holder == holder && _held.Remove(name);
    }
}
