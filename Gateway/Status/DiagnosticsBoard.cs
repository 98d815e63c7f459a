using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status;

/// <summary>What each headset and adapter said last of itself. Any thread; however many names come, so many are kept.</summary>
sealed class DiagnosticsBoard(TimeProvider time)
{
    /// <summary>More have not spoken within the seconds after which they are forgotten, unless somebody makes names up.</summary>
    internal const int Greatest = 512;

    internal const int GreatestValues = 256;

    /// <summary>As long as the lines of the adapters' log: why a server's certificate is refused, and what to do, takes half of it.</summary>
    internal const int GreatestValue = 1000;

    /// <summary>Letters of names and values together.</summary>
    internal const int GreatestLength = 16 * 1024;

    /// <summary>Headsets only: an adapter that is gone is a fault until the gateway is started again.</summary>
    internal static readonly TimeSpan ForgottenAfter = TimeSpan.FromSeconds(30);

    readonly Lock _lock = new();
    readonly Dictionary<string, (long At, KeyValuePair<string, string>[] Values)> _said = [];

    public void Add(DiagnosticsMessage message)
    {
        var values = Kept(message.Values);
        lock (_lock)
        {
            if (_said.Count >= Greatest && !_said.ContainsKey(message.HardwareId)) MakeRoom();
            _said[message.HardwareId] = (time.GetTimestamp(), values);
        }
    }

    /// <summary>Removes a headset that has left. An adapter that is gone stays a fault.</summary>
    public void Remove(string name)
    {
        if (StatusObjects.IsAdapter(name)) return;
        lock (_lock) _said.Remove(name);
    }

    /// <summary>In the order of their names.</summary>
    public IReadOnlyList<(string Name, TimeSpan Ago, IReadOnlyList<KeyValuePair<string, string>> Values)> Read()
    {
        lock (_lock)
        {
            foreach (var (name, said) in _said)
                if (!StatusObjects.IsAdapter(name) && time.GetElapsedTime(said.At) > ForgottenAfter) _said.Remove(name);
            return
            [
                .. _said.OrderBy(said => said.Key, StringComparer.Ordinal)
                    .Select(said => (said.Key, time.GetElapsedTime(said.Value.At), (IReadOnlyList<KeyValuePair<string, string>>)said.Value.Values)),
            ];
        }
    }

    // Not the message itself: 64 KiB each would be too much to keep of hundreds.
    static KeyValuePair<string, string>[] Kept(IEnumerable<KeyValuePair<string, string>> values)
    {
        var room = GreatestLength;
        return
        [
            .. values.Where(pair => !AdapterJointReport.IsKey(pair.Key)).Take(GreatestValues).Select(pair => KeyValuePair.Create(pair.Key, InputException.OneLine(pair.Value, GreatestValue)))
                .TakeWhile(pair => (room -= pair.Key.Length + pair.Value.Length) >= 0),
        ];
    }

    // Whoever is there speaks once a second: the one that was silent longest is the one to go.
    void MakeRoom() => _said.Remove(_said.OrderBy(said => StatusObjects.IsAdapter(said.Key)).ThenBy(said => said.Value.At).First().Key);
}
