namespace Nowpose.UnityPlayer;

/// <summary>Console of a player. Any thread may add entries. The first 1000 entries do not allocate.</summary>
sealed class PlayerLog
{
    readonly List<PlayerLogEntry> _entries = new(1000);

    internal IReadOnlyList<PlayerLogEntry> Entries
    {
        get
        {
            lock (_entries) return _entries.ToArray();
        }
    }

    internal void Add(LogType type, string message, Exception exception, Object context)
    {
        lock (_entries) _entries.Add(new PlayerLogEntry(type, message, exception, context));
    }
}
