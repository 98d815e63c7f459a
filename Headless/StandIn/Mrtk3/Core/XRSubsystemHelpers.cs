using MixedReality.Toolkit.Subsystems;

namespace MixedReality.Toolkit;

public static class XRSubsystemHelpers
{
    [ThreadStatic] static IKeywordRecognitionSubsystem _recognition;

    /// <summary>The keyword recognition if it is running; otherwise null.</summary>
    public static IKeywordRecognitionSubsystem KeywordRecognitionSubsystem => _recognition?.running == true ? _recognition : null;

    /// <summary>Sets the simulated keyword recognition; null removes it.</summary>
    internal static void Provide(IKeywordRecognitionSubsystem recognition) => _recognition = recognition;
}
