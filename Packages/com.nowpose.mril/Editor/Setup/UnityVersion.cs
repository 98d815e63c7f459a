using System;
using System.Globalization;
using System.Text.RegularExpressions;

namespace Nowpose.Editor.Setup
{
    /// <summary>A version of the Unity editor, for example 2022.3.62f1.</summary>
    readonly struct UnityVersion
    {
        static readonly Regex Pattern = new Regex(@"^(\d{1,5})\.(\d{1,5})\.(\d{1,5})[a-z]", RegexOptions.CultureInvariant);
        static readonly Regex ProjectLine = new Regex(@"^m_EditorVersion:[ \t]*(\S+)", RegexOptions.Multiline | RegexOptions.CultureInvariant);

        UnityVersion(string text, Version number)
        {
            Text = text;
            Number = number;
        }

        /// <summary>Version in Unity's notation.</summary>
        public string Text { get; }

        /// <summary>Version number: year or generation, release and patch, without the suffix after the patch.</summary>
        public Version Number { get; }

        /// <summary>Reads a version in Unity's notation.</summary>
        /// <returns>Null if the text is not a version of Unity.</returns>
        public static UnityVersion? TryParse(string text)
        {
            var match = Pattern.Match(text ?? "");
            if (!match.Success) return null;
            return new UnityVersion(text, new Version(Part(match, 1), Part(match, 2), Part(match, 3)));
        }

        /// <summary>Reads the version from the text of a project's ProjectSettings/ProjectVersion.txt.</summary>
        /// <returns>Null if the text contains no version.</returns>
        public static UnityVersion? InProjectFile(string text)
        {
            var line = ProjectLine.Match(text);
            return line.Success ? TryParse(line.Groups[1].Value) : null;
        }

        public override string ToString() => Text;

        static int Part(Match match, int group) => int.Parse(match.Groups[group].Value, CultureInfo.InvariantCulture);
    }
}
