using System;
using MixedReality.Toolkit;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Mrtk3
{
    /// <summary>
    /// Shows the question that a pairing asks the wearer, with one button to accept and one to decline. Voice commands do not press the first button.
    /// </summary>
    /// <remarks>
    /// Speech recognition makes mistakes, and the microphone also picks up other people. The wearer therefore accepts a gateway by hand or by
    /// gaze and pinch. Declining by voice is possible, because it connects the headset to nothing new. <see cref="CellPairing.Refuse"/>
    /// states when the pairing asks about a declined gateway again.
    /// </remarks>
    [AddComponentMenu("Nowpose/Consent Prompt")]
    [DisallowMultipleComponent]
    public sealed class ConsentPrompt : MonoBehaviour
    {
        [SerializeField, Tooltip("The pairing whose question is shown. Empty: the pairing on this object or a parent.")]
        CellPairing _pairing = null;

        [SerializeField, Tooltip("The object that is shown while a question is open. It must be a child of this object.")]
        GameObject _content = null;

        [SerializeField, Tooltip("Text Mesh that shows the question. Empty: the question is not shown. Assign one, because users must read the "
            + "question before they agree.")]
        TextMesh _question = null;

        [SerializeField, Tooltip("Button to agree. Its event calls Accept.")]
        StatefulInteractable _accept = null;

        [SerializeField, Tooltip("Button to decline. Its event calls Refuse.")]
        StatefulInteractable _refuse = null;

        /// <summary>Maximum line width as a multiple of the font size. The question then fits its background.</summary>
        const float LineWidth = 30;

        /// <summary>Minimum time to read a question, in s. An earlier press was not an answer to this question.</summary>
        const float ReadingSeconds = 0.5f;

        [NonSerialized] string _shown = "";
        double _shownAt;

        /// <summary>
        /// Accepts the gateway. The event of the accept button must call this method. Does nothing in the first half second after the question
        /// appears.
        /// </summary>
        public void Accept()
        {
            if (IsRead) _pairing.Accept();
        }

        /// <summary>
        /// Declines the gateway. The event of the decline button must call this method. Does nothing in the first half second after the question
        /// appears.
        /// </summary>
        public void Refuse()
        {
            if (IsRead) _pairing.Refuse();
        }

        bool IsRead => _pairing != null && _pairing.Question == _shown && Time.unscaledTimeAsDouble - _shownAt >= ReadingSeconds;

        void OnEnable()
        {
            if (_pairing == null) _pairing = GetComponentInParent<CellPairing>();
            if (_pairing == null) ConsoleLog.Warn(this, Mrtk3Messages.PromptWithoutPairing(name));
            Show(null);
        }

        // Not in LateUpdate, so that Body Follow places the content in the same frame.
        void Update()
        {
            var question = _pairing != null ? _pairing.Question : null;
            if (question != _shown) Show(question);
        }

        void Show(string question)
        {
            _shown = question;
            _shownAt = Time.unscaledTimeAsDouble;
            if (_question != null) _question.text = question == null ? "" : WrappedText.Of(question, LineWidth);
            if (_content != null) _content.SetActive(question != null);
            if (question == null) return;
            AllowVoice(_accept, false);
            AllowVoice(_refuse, true);
        }

        // MRTK3 before 3.1 throws if the property is changed before the button is first active.
        static void AllowVoice(StatefulInteractable button, bool isAllowed)
        {
            if (button != null && button.isActiveAndEnabled) button.AllowSelectByVoice = isAllowed;
        }
    }
}
