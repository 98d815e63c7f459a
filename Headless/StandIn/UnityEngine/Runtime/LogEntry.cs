using System;

namespace UnityEngine;

/// <summary>One entry of the console.</summary>
readonly struct LogEntry
{
    internal LogEntry(LogType type, string message, Exception exception, Object context)
    {
        Type = type;
        Message = message;
        Exception = exception;
        Context = context;
    }

    internal LogType Type { get; }
    internal string Message { get; }

    /// <summary>The logged exception; null if the entry is a message.</summary>
    internal Exception Exception { get; }

    internal Object Context { get; }
}
