using System;
using System.IO;

namespace UnityEngine;

/// <summary>The application around the engine.</summary>
sealed class Host
{
    readonly object _lock = new();

    internal event Application.LogCallback LogReceived;

    /// <summary>Version of the editor, or of the player's engine.</summary>
    internal string UnityVersion { get; set; } = "2022.3.62f1";

    internal bool RunInBackground { get; set; } = true;
    internal bool Focused { get; set; } = true;

    /// <summary>Where the application may keep files; nobody makes it before something is kept.</summary>
    internal string PersistentDataPath { get; set; } = Path.Combine(Path.GetTempPath(), "Nowpose Player");

    /// <summary>What is shipped beside the application as files; an address where it lies in an archive.</summary>
    internal string StreamingAssetsPath { get; set; } = Path.Combine(Path.GetTempPath(), "Nowpose Player", "StreamingAssets");

    internal int SubscriberCount => Count(LogReceived);

    internal static int Count(Delegate d) => d?.GetInvocationList().Length ?? 0;

    internal void Logged(LogEntry entry)
    {
        lock (_lock) LogReceived?.Invoke(entry.Message, entry.Exception?.StackTrace ?? "", entry.Type);
    }
}
