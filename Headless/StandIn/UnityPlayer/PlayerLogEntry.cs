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

    /// <summary>The exception that a script threw or logged; null for none.</summary>
    public Exception Exception { get; }

    /// <summary>The object that the entry refers to; null for none.</summary>
    public UnityEngine.Object Context { get; }

    public override string ToString() => $"{Type}: {Message}{(Exception == null ? "" : "\n" + Exception)}";
}
