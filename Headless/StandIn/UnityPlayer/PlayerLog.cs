using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>Console of a player. Any thread may add entries. The first 1000 entries do not allocate.</summary>
sealed class PlayerLog
{
    readonly List<LogEntry> _lines = new(1000);

    internal IReadOnlyList<PlayerLogEntry> Entries
    {
        get
        {
            lock (_lines) return _lines.ConvertAll(line => new PlayerLogEntry(line.Type, line.Message, line.Exception, line.Context));
        }
    }

    internal void Add(LogEntry line)
    {
        lock (_lines) _lines.Add(line);
    }
}
