using System;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>One entry of the console of a player.</summary>
public readonly struct PlayerLogEntry
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

    /// <summary>The exception that a script has thrown or logged; null if the entry is a message.</summary>
    public Exception Exception { get; }

    /// <summary>The object to which the entry refers; null if there is none.</summary>
    public UnityEngine.Object Context { get; }

    public override string ToString() => $"{Type}: {Message}{(Exception == null ? "" : "\n" + Exception)}";
}
