using System;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>One line of a player's console.</summary>
public sealed class PlayerLogEntry
{
    internal PlayerLogEntry(LogType type, string message, Exception exception, UnityEngine.Object context)
    {
        Type = type;
        Message = message;
        Exception = exception;
        Context = context;
    }

    public LogType Type { get; }
    public string Message { get; }

    /// <summary>Null unless a script threw one or logged one.</summary>
    public Exception Exception { get; }

    /// <summary>What the entry is about; null where it did not say.</summary>
    public UnityEngine.Object Context { get; }

    public override string ToString() => $"{Type}: {Message}{(Exception == null ? "" : "\n" + Exception)}";
}
