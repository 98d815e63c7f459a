using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>Calculates the font size at which text is legible from a distance, and the font size of a TextMesh.</summary>
    static class LetterSize
    {
        /// <summary>Minimum angular height of a capital letter in degrees. Microsoft's minimum for HoloLens 2 at 2 m is 0.35° to 0.4°.</summary>
        const float MinCapitalDegrees = 0.5f;

        /// <summary>
        /// Height of a capital letter as a fraction of the font size: 1409/2048 in Liberation Sans, Unity's built-in font. Arial has 0.716.
        /// </summary>
        const float CapitalHeight = 0.688f;

        /// <summary>Size of text in metres per point of the font, at character size 1 and scale 1.</summary>
        const float MetresPerPoint = 0.1f;

        /// <summary>Font size in points that Unity uses for the value 0.</summary>
        const int DefaultPoints = 13;

        /// <summary>Returns the font size, in metres, at which capital letters are 0.5° high when seen from a distance, in metres.</summary>
        public static float At(float distance) => 2 * distance * Mathf.Tan(MinCapitalDegrees / 2 * Mathf.Deg2Rad) / CapitalHeight;

        /// <summary>Returns the font size of a TextMesh in metres, for scale 1.</summary>
        public static float Of(TextMesh text) =>
            MetresPerPoint * text.characterSize * (text.fontSize > 0 ? text.fontSize : DefaultPoints);
    }
}
