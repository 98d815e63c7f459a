using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>Converts between the size of a font and the height of its capital letters as seen from a distance.</summary>
    static class LetterSize
    {
        /// <summary>Minimum height of a capital letter, in degrees. Microsoft's minimum for HoloLens 2 at 2 m is 0.35° to 0.4°.</summary>
        const float MinCapitalDegrees = 0.5f;

        /// <summary>Height of a capital letter as a share of the font size: 1409/2048 in Liberation Sans, the built-in font. Arial: 0.716.</summary>
        const float CapitalHeight = 0.688f;

        /// <summary>Size of text in metres per point of the font, at character size 1 and scale 1.</summary>
        const float MetresPerPoint = 0.1f;

        /// <summary>The size in points that the engine uses for a font size of 0.</summary>
        const int DefaultPoints = 13;

        /// <summary>Returns the font size whose capital letters are 0.5° high at a distance, both in metres.</summary>
        public static float At(float distance) => 2 * distance * Mathf.Tan(MinCapitalDegrees / 2 * Mathf.Deg2Rad) / CapitalHeight;

        /// <summary>Returns the font size of a text at scale 1, in metres.</summary>
        public static float Of(TextMesh text) =>
            MetresPerPoint * text.characterSize * (text.fontSize > 0 ? text.fontSize : DefaultPoints);
    }
}
