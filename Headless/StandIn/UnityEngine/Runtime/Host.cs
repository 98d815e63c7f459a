namespace UnityEngine;

/// <summary>Properties of the application in which the engine runs.</summary>
sealed class Host
{
    readonly object _lock = new();

    internal event Application.LogCallback LogReceived;

    /// <summary>Unity version of the editor or player.</summary>
    internal string UnityVersion { get; } = "2022.3.62f1";

    internal RuntimePlatform Platform { get; set; } = RuntimePlatform.WindowsPlayer;
    internal string DeviceName { get; set; } = "Stand-in 1";
    internal string DeviceIdentifier { get; set; } = "0123456789abcdef";
    internal bool RunInBackground { get; set; } = true;
    internal bool Focused { get; set; } = true;

    /// <summary>Folder for files that the application writes. It is created when the first file is written.</summary>
    internal string PersistentDataPath { get; set; } = Path.Combine(Path.GetTempPath(), "Nowpose Player");

    /// <summary>Folder of the files shipped with the application; a URL if they are in an archive.</summary>
    internal string StreamingAssetsPath { get; set; } = Path.Combine(Path.GetTempPath(), "Nowpose Player", "StreamingAssets");

    internal int SubscriberCount => Count(LogReceived);

    internal static int Count(Delegate d) => d?.GetInvocationList().Length ?? 0;

    internal void Logged(LogType type, string message, Exception exception)
    {
        lock (_lock) LogReceived?.Invoke(message, exception?.StackTrace ?? "", type);
    }
}
