using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>The console of a player. Lines may come from any thread; the first thousand need no allocation.</summary>
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
