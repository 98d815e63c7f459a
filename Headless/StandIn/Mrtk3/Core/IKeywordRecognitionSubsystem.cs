using UnityEngine;
using UnityEngine.Events;

namespace MixedReality.Toolkit.Subsystems;

public interface IKeywordRecognitionSubsystem : ISubsystem
{
    UnityEvent CreateOrGetEventForKeyword(string keyword);
    IReadOnlyDictionary<string, UnityEvent> GetAllKeywords();
    void RemoveKeyword(string keyword);
}
