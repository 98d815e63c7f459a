using System;
using System.Collections.Generic;

namespace UnityEngine;

/// <summary>The application around the engine: its window, its events.</summary>
sealed class Host
{
    readonly object _lock = new();

    internal event Action<bool> FocusChanged;
    internal event Action Quitting;
    internal event Application.LogCallback LogReceived;

    internal bool RunInBackground { get; set; } = true;
    internal bool Focused { get; set; } = true;
    internal int TargetFrameRate { get; set; } = -1;

    internal int SubscriberCount => Count(FocusChanged) + Count(Quitting) + Count(LogReceived);

    internal static int Count(Delegate d) => d?.GetInvocationList().Length ?? 0;

    internal void ChangeFocus(bool focused)
    {
        Focused = focused;
        Callbacks.Call(FocusChanged, focused);
    }

    internal void Quit() => Callbacks.Call(Quitting == null ? null : new Events.UnityAction(Quitting));

    internal void Logged(LogEntry entry)
    {
        lock (_lock) LogReceived?.Invoke(entry.Message, entry.Exception?.StackTrace ?? "", entry.Type);
    }
}
