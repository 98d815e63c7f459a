using MixedReality.Toolkit.Subsystems;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Mrtk3;

/// <summary>Simulates keyword recognition: a test says the keywords.</summary>
sealed class SpokenKeywords : IKeywordRecognitionSubsystem
{
    readonly Dictionary<string, UnityEvent> _events = [];

    public bool running { get; set; } = true;

    public UnityEvent CreateOrGetEventForKeyword(string keyword)
    {
        if (!_events.TryGetValue(keyword, out var happened)) _events.Add(keyword, happened = new UnityEvent());
        return happened;
    }

    /// <summary>Whether keyword recognition is supported on the simulated platform.</summary>
    public bool IsSupported { get; set; } = true;

    public int Calls { get; private set; }

    public IReadOnlyDictionary<string, UnityEvent> GetAllKeywords()
    {
        Calls++;
        return IsSupported ? _events : null;
    }


    public void RemoveKeyword(string keyword) => _events.Remove(keyword);

    /// <summary>Simulates that the wearer says a keyword.</summary>
    /// <returns>True if the keyword is registered.</returns>
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
