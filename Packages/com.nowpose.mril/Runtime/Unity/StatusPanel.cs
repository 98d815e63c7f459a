using Nowpose.Unity.Anchoring;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Shows the status of a session in the scene: clock, latencies, render time, connection and error reduction.</summary>
    /// <remarks>
    /// The panel consists of copies of the text object <c>Cell</c>, in rows of label, value and note, with the message at the top. Its lower edge
    /// is 7 font sizes below this object's position. At scale 1, capital letters are at least 0.5° high for the viewer. The panel does not move by
    /// itself; add <see cref="BodyFollow"/> to the same object to keep it in view.
    /// </remarks>
    [AddComponentMenu("Nowpose/Status Panel")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder + 2)]
    [DisallowMultipleComponent]
    public sealed class StatusPanel : MonoBehaviour
    {
        [SerializeField, Tooltip("The session whose status is shown. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("A Text Mesh below this object. Every label of the panel copies its font, material, style and colour. Keep it "
            + "inactive.")]
        TextMesh _cell = null;

        [SerializeField, Tooltip("Material of the background, which is drawn before the text. Empty: no background.")]
        Material _ground = null;

        [SerializeField, Tooltip("Child of this object that stays below the panel's lower edge, such as a bar to grasp the panel by. It is scaled so "
            + "that one of its units is one font size. Empty: none.")]
        Transform _bar = null;

        [SerializeField, Range(0.1f, 2), Tooltip("Time between two updates of the text in seconds. Default 0.25: numbers that change faster "
            + "cannot be read.")]
        float _refreshSeconds = 0.25f;

        [SerializeField, Tooltip("Show the reduction of each joint's error over 10 s in percent on the first line, while there is no problem to "
            + "report. Off: only the reduction of the tool error is shown.")]
        bool _showJoints = false;

        readonly StatusTexts _texts = new StatusTexts();
        readonly SessionBases _bases = new SessionBases();
        MrilSession _source;
        CellPairing _pairing;
        LatencyNudge _nudge;
        ReadingDistance _distance;
        double _due;

        internal StatusTexts Texts => _texts;

        /// <summary>
        /// The text objects and their background in the scene; null until they are created, and after Unity has recompiled the scripts in play mode.
        /// </summary>
        internal PanelCells Cells { get; set; }

        /// <summary>
        /// Maximum distance in metres at which the letters are high enough to be legible; null before the panel is first drawn for a viewer.
        /// </summary>
        internal float? LegibleMetres => _distance.Metres > 0 ? _distance.Metres : (float?)null;

        void OnEnable()
        {
            _source = this.RequiredSession(_session, "status panel");
            _pairing = _source != null ? _source.GetComponentInChildren<CellPairing>(true) : null;
            _nudge = _source != null ? _source.GetComponentInChildren<LatencyNudge>(true) : null;
            _due = 0;
            if (_cell == null) ConsoleLog.Fail(this, ComponentMessages.PanelWithoutText(name));
        }

        // Hides the text objects, because they are not updated while this component is disabled.
        void OnDisable() => Cells?.Hide();

        void OnDestroy() => Cells?.Destroy();

        void LateUpdate()
        {
            if (_cell == null || Time.unscaledTimeAsDouble < _due) return;
            _due = Time.unscaledTimeAsDouble + _refreshSeconds;
            if (Cells == null || Cells.IsDestroyed) MakeCells();
            _texts.ShowsJointErrors = _showJoints;
            if (_source == null) _texts.Update(null, null, null, null);
            else _texts.Update(_source.Statistics, _source.Settings, _source.Robot?.Name, _source.Problem, _bases.WorstOf(_source), _pairing,
                _source.Parts, _nudge);
            Cells.Show(_texts);
            var viewer = Viewer.Head;
            if (viewer == null) return;
            _distance.Update(Vector3.Distance(transform.position, viewer.position));
            Resize(LetterSize.At(_distance.Metres));
        }

        // Compensates for the scale of the parents. The panel's own scale, which the user may set, still applies.
        void Resize(float size)
        {
            var above = transform.parent != null ? Mathf.Abs(transform.parent.lossyScale.x) : 1;
            if (above > 0) size /= above;
            Cells.Resize(size);
            if (_bar == null) return;
            _bar.localScale = Vector3.one * size;
            _bar.localPosition = new Vector3(0, PanelCells.LowerEdge * size, 0);
        }

        // Must not be called in OnEnable, because Unity does not allow new children while it enables objects. Removes earlier text objects first:
        // when Unity recompiles scripts in play mode, the objects remain but the references to them are lost.
        void MakeCells()
        {
            PanelCells.RemoveFrom(transform);
            Cells = new PanelCells(transform, _cell, _ground);
            _distance = default;
        }
    }
}
