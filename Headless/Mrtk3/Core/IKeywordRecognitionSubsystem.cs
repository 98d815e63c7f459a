using UnityEngine;
using UnityEngine.Events;

namespace MixedReality.Toolkit.Subsystems;

public interface IKeywordRecognitionSubsystem : ISubsystem
{
    UnityEvent CreateOrGetEventForKeyword(string keyword);
}
