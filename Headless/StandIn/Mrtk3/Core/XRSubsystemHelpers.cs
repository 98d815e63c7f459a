using System;
using MixedReality.Toolkit.Subsystems;

namespace MixedReality.Toolkit;

public static class XRSubsystemHelpers
{
    [ThreadStatic] static IKeywordRecognitionSubsystem _recognition;

    /// <summary>Null while none runs.</summary>
    public static IKeywordRecognitionSubsystem KeywordRecognitionSubsystem => _recognition?.running == true ? _recognition : null;

    /// <summary>What a test plays the recognition with; null for none.</summary>
    internal static void Provide(IKeywordRecognitionSubsystem recognition) => _recognition = recognition;
}
