using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>The console of a player; entries may come from any thread.</summary>
sealed class PlayerLog
{
    readonly List<PlayerLogEntry> _entries = new();

    internal IReadOnlyList<PlayerLogEntry> Entries
    {
        get
        {
            lock (_entries) return _entries.ToArray();
        }
    }

    internal void Add(LogEntry entry)
    {
        lock (_entries) _entries.Add(new PlayerLogEntry(entry.Type, entry.Message, entry.Exception, entry.Context));
    }
}
