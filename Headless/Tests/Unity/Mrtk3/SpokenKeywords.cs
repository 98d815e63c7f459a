using MixedReality.Toolkit.Subsystems;
using UnityEngine.Events;

namespace Nowpose.Headless.Tests.Unity.Mrtk3;

/// <summary>A keyword recognition that hears what a test says.</summary>
sealed class SpokenKeywords : IKeywordRecognitionSubsystem
{
    readonly Dictionary<string, UnityEvent> _events = [];

    public bool running { get; set; } = true;

    public UnityEvent CreateOrGetEventForKeyword(string keyword)
    {
        if (!_events.TryGetValue(keyword, out var happened)) _events.Add(keyword, happened = new UnityEvent());
        return happened;
    }

    /// <returns>Whether anybody ever asked for it.</returns>
    public bool Say(string keyword)
    {
        if (!running || !_events.TryGetValue(keyword, out var happened)) return false;
        happened.Invoke();
        return true;
    }

    public void Start() => running = true;
    public void Stop() => running = false;
    public void Destroy() => running = false;
}
