using System;
using System.IO;
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

    public static event Action<bool> focusChanged
    {
        add => Host.FocusChanged += value;
        remove => Host.FocusChanged -= value;
    }

    public static event Action quitting
    {
        add => Host.Quitting += value;
        remove => Host.Quitting -= value;
    }

    public static event LogCallback logMessageReceived
    {
        add => Host.LogReceived += value;
        remove => Host.LogReceived -= value;
    }

    public static bool isPlaying => World.Current.IsPlaying;
    public static bool isFocused => Host.Focused;
    public static bool isEditor => !isPlaying;
    public static bool isBatchMode => true;
    public static bool isMobilePlatform => false;
    public static RuntimePlatform platform => RuntimePlatform.LinuxPlayer;
    public static string unityVersion => "2022.3.62f1";
    public static string productName => "Nowpose";
    public static string version => "0.1.0";
    public static string dataPath => Directory.GetCurrentDirectory();
    public static string streamingAssetsPath => Path.Combine(dataPath, "StreamingAssets");
    public static string persistentDataPath => Path.Combine(Path.GetTempPath(), "nowpose-player");
    public static string temporaryCachePath => Path.Combine(Path.GetTempPath(), "nowpose-player-cache");

    public static bool runInBackground
    {
        get => Host.RunInBackground;
        set => Host.RunInBackground = value;
    }

    public static int targetFrameRate
    {
        get => Host.TargetFrameRate;
        set => Host.TargetFrameRate = value;
    }

    static Host Host => World.Current.Host;

    public static bool IsPlaying(Object obj) => obj && obj.World.IsPlaying;
}
