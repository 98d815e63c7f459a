using System;
using Nowpose.Messages;

namespace Nowpose.Latency.Conditions
{
    /// <summary>Names of display conditions in files and in messages.</summary>
    static class DisplayConditionNames
    {
        static readonly string[] Fields =
        {
            "device", "display_hz", "graphics_api", "graphics_jobs", "render_pipeline", "rewrite_before_render", "latency_optimization",
            "reprojection",
        };

        static readonly string[] Labels =
        {
            "device", "refresh rate", "graphics API", "Graphics Jobs", "render pipeline", "Rewrite Before Render", "Latency Optimization",
            "reprojection mode",
        };

        static readonly string[] Places =
        {
            "", "", "Project Settings, Player", "Project Settings, Player", ConditionMessages.PlaceOfQuality,
            "Session Settings", ConditionMessages.PlaceOfOpenXr, ConditionMessages.PlaceOfReprojection,
        };

        public static int Count => Fields.Length;

        /// <summary>Returns the name of the field in files and diagnostics.</summary>
        public static string FieldOf(DisplayCondition condition) => Fields[(int)condition];

        /// <summary>Returns the name used in messages, as Unity or an Inspector shows it.</summary>
        public static string LabelOf(DisplayCondition condition) => Labels[(int)condition];

        /// <summary>Returns the name for the first column of a table.</summary>
        public static string TitleOf(DisplayCondition condition) => char.ToUpperInvariant(LabelOf(condition)[0]) + LabelOf(condition).Substring(1);

        /// <summary>Returns the place where the user can change the condition.</summary>
        public static string PlaceOf(DisplayCondition condition) => Places[(int)condition];

        /// <param name="field">Name exactly as returned by <see cref="FieldOf"/>.</param>
        public static bool TryParse(string field, out DisplayCondition condition)
        {
            var index = Array.IndexOf(Fields, field);
            condition = (DisplayCondition)Math.Max(0, index);
            return index >= 0;
        }
    }
}
