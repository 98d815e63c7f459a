using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>How large letters must be.</summary>
    static class LetterSize
    {
        /// <summary>Letters lower than half a degree are hard to read on a headset.</summary>
        const float LeastDegrees = 0.5f;

        /// <summary>Height of a letter without ascender, as part of the font size: Arial's.</summary>
        const float XHeight = 0.519f;

        /// <summary>Size of text in metres per point of the font, at character size 1 and scale 1.</summary>
        const float MetresPerPoint = 0.1f;

        /// <summary>What the engine takes for a font size of 0.</summary>
        const int DefaultPoints = 13;

        /// <summary>Font size that can be read at a distance, both in metres.</summary>
        public static float At(float distance) => 2 * distance * Mathf.Tan(LeastDegrees / 2 * Mathf.Deg2Rad) / XHeight;

        /// <summary>Font size of a text at scale 1, metres.</summary>
        public static float Of(TextMesh text) =>
            MetresPerPoint * text.characterSize * (text.fontSize > 0 ? text.fontSize : DefaultPoints);
    }
}
