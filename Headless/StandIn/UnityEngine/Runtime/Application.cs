using UnityEngine.Events;

namespace UnityEngine;

public class Application
{
    public delegate void LogCallback(string condition, string stackTrace, LogType type);

    public static event UnityAction onBeforeRender
    {
        add => World.Current.BeforeRender.Add(value);
        remove => World.Current.BeforeRender.Remove(value);
    }

    public static event LogCallback logMessageReceived
    {
        add => Host.LogReceived += value;
        remove => Host.LogReceived -= value;
    }

    public static bool isPlaying => World.Current.IsPlaying;
    public static bool isEditor => !isPlaying;
    public static RuntimePlatform platform => Host.Platform;
    public static string unityVersion => Host.UnityVersion;

    public static bool runInBackground
    {
        get => Host.RunInBackground;
        set => Host.RunInBackground = value;
    }

    public static string persistentDataPath => Host.PersistentDataPath;
    public static string streamingAssetsPath => Host.StreamingAssetsPath;

    static Host Host => World.Current.Host;
}
