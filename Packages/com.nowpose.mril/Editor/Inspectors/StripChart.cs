using System;
using System.Globalization;
using Nowpose.Editor.Messages;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Draws a small chart of the last ten seconds, with the newest value in its corner ("–" while it is unknown).</summary>
    sealed class StripChart
    {
        const float Height = 54;
        const float LineWidth = 2;
        const double Seconds = 10;

        // Minimum time between two values, s. At 50 values per second, ten seconds contain more values than the chart has pixels.
        const double Interval = 0.02;
        const int Capacity = 600;

        static readonly Color Background = new Color(0, 0, 0, 0.25f);
        static readonly Color Line = new Color(0.45f, 0.8f, 1);

        readonly string _label, _unit;
        readonly RollingSeries _series = new RollingSeries(Capacity, Seconds);
        readonly Vector3[] _points = new Vector3[Capacity];

        /// <param name="unit">Unit of the values.</param>
        public StripChart(string label, string unit)
        {
            _label = label;
            _unit = unit;
        }

        /// <summary>Records a value. Ignores values that follow the previous value too quickly.</summary>
        /// <param name="time">Time in s.</param>
        /// <param name="value">The value; null while it is unknown.</param>
        public void Take(double time, double? value)
        {
            if (_series.Count > 0 && Math.Abs(time - _series.TimeAt(_series.Count - 1)) < Interval) return;
            _series.Add(time, value);
        }

        /// <summary>Draws the chart in the full width of the inspector.</summary>
        public void Draw() => Draw(EditorGUILayout.GetControlRect(false, Height));

        internal void Draw(Rect area)
        {
            var range = ChartRange.Of(_series);
            EditorGUI.DrawRect(area, Background);
            DrawLine(area, range);
            GUI.Label(Row(area, area.yMin), _label + " " + Text(_series.Newest) + "   " + InspectorTexts.AtTop(Text(range.Top)), EditorStyles.miniLabel);
            if (range.Bottom < 0) GUI.Label(Row(area, area.yMax - EditorGUIUtility.singleLineHeight), Text(range.Bottom), EditorStyles.miniLabel);
        }

        // Draws the values as lines, with gaps at unknown values.
        void DrawLine(Rect area, ChartRange range)
        {
            var before = Handles.color;
            Handles.color = Line;
            var count = 0;
            for (var i = 0; i < _series.Count; i++)
            {
                var value = _series.ValueAt(i);
                if (float.IsNaN(value)) count = Flush(count);
                else _points[count++] = new Vector3(X(area, i), area.yMax - range.PartOf(value) * area.height);
            }
            Flush(count);
            Handles.color = before;
        }

        int Flush(int count)
        {
            if (count > 1) Handles.DrawAAPolyLine(LineWidth, count, _points);
            return 0;
        }

        float X(Rect area, int index)
        {
            var age = _series.TimeAt(_series.Count - 1) - _series.TimeAt(index);
            return area.xMax - (float)(age / _series.Seconds) * area.width;
        }

        string Text(float value) => float.IsNaN(value) ? LiveText.Unknown : value.ToString("0.##", CultureInfo.InvariantCulture) + " " + _unit;

        static Rect Row(Rect area, float y) => new Rect(area.xMin + 4, y, area.width - 8, EditorGUIUtility.singleLineHeight);
    }
}
